#pragma once

#include "image/draw_text.h"
#include "image/image.h"

// A part of a picture, in pixels; last ones are not in it.
struct Region {
    int first_column;
    int last_column;
    int first_row;
    int last_row;
};

inline int count_ink(const raysteps::Image& image, const Region& region) {
    int count = 0;
    for (int row = region.first_row; row < region.last_row; row++) {
        for (int column = region.first_column; column < region.last_column; column++) {
            count += image.at(column, row) == raysteps::ink_color ? 1 : 0;
        }
    }
    return count;
}

inline int count_paper(const raysteps::Image& image, const Region& region) {
    int count = 0;
    for (int row = region.first_row; row < region.last_row; row++) {
        for (int column = region.first_column; column < region.last_column; column++) {
            count += image.at(column, row) == raysteps::paper_color ? 1 : 0;
        }
    }
    return count;
}
