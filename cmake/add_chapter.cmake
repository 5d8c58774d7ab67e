function(add_chapter)
endfunction()
