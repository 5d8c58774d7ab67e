Raysteps.play.offerScene("mirrors", "data/scene_mirrors.js");
Raysteps.play.offerScene("cornell_box", "data/scene_cornell_box.js");
Raysteps.play.offerScene("tetrahedron:2", "data/scene_tetrahedron_2.js");
