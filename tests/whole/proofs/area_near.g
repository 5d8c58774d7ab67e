#: at most 4 e area: area of two products that are nearly equal, as a part of itself
# One product is over 1024 times their difference, so they have one sign. Scaled by a power of two, the larger is in
# [1, 2]. Their rounded difference is exact then, and what the first one adds to it is little enough to be exact too, or
# so much that little is lost beside it. Dekker (1971) proves by hand that the missing parts are exact.

@rnd = float<24, ne>;
a_x = rnd(any_a_x);
a_y = rnd(any_a_y);
b_x = rnd(any_b_x);
b_y = rnd(any_b_y);
first rnd= {shaders/triangle/watertight/exact_area.glsl exact_area first};
second rnd= {shaders/triangle/watertight/exact_area.glsl exact_area second};
true_first = a_x * b_y;
true_second = a_y * b_x;
true_area = true_first - true_second;
missing_part_first = true_first - first;
missing_part_second = true_second - second;
area rnd= {shaders/triangle/watertight/exact_area.glsl exact_area area};

# The sum as it grows.
difference = rnd(first - second);
with_first = rnd(difference + missing_part_first);

{
  |true_area| in [1b-400, 1b-9] /\
  [[
    true_first in [1, 2] /\ true_second in [0.999, 2] /\ |true_first - second| <= 15b-27
  or
    true_first in [0.999, 2] /\ true_second in [0.999, 2] /\ |true_first - second| in [15b-27, 1]
  or # the second is rounded to 1 itself
    true_first in [0.999, 1] /\ true_second in [1, 2] /\ |true_first - second| <= 15b-27 /\
    (true_first - second) / true_area in [0, 1]
  ]]
  -> area -/ true_area in ?
}

first - second -> (first - true_first) + true_area + (true_second - second);
difference + missing_part_first -> (true_first - second) + (difference - (first - second));
(area - true_area) / true_area ->
  (area - (with_first - missing_part_second)) / true_area +
  (with_first - (difference + missing_part_first)) / true_area +
  (difference - (first - second)) / true_area { true_area <> 0 };
(difference + missing_part_first) / true_area ->
  (difference - (first - second)) / true_area + (true_first - second) / true_area { true_area <> 0 };
(with_first - missing_part_second) / true_area ->
  (with_first - (difference + missing_part_first)) / true_area +
  (difference - (first - second)) / true_area + 1 { true_area <> 0 };
(true_first - second) / true_area ->
  1 / (1 - missing_part_second / (true_first - second)) { true_first - second <> 0, true_area <> 0 };
