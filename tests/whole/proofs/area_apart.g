#: at most 4 e area: area of two products that are apart, as a part of itself
# Neither product is over 1024 times their difference. Dekker (1971) proves by hand that the missing parts are exact.

@rnd = float<24, ne>;
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
  |true_area| in [1b-400, 1b400] /\
  |true_first / true_area| <= 1024 /\
  |true_second / true_area| <= 1024
  -> area -/ true_area in ?
}

(area - true_area) / true_area ->
  (area - (with_first - missing_part_second)) / true_area +
  (with_first - (difference + missing_part_first)) / true_area +
  (difference - (first - second)) / true_area { true_area <> 0 };
(first - second) / true_area ->
  1 - missing_part_first / true_area + missing_part_second / true_area { true_area <> 0 };
(difference + missing_part_first) / true_area ->
  (difference - (first - second)) / true_area + 1 + missing_part_second / true_area { true_area <> 0 };
(with_first - missing_part_second) / true_area ->
  (with_first - (difference + missing_part_first)) / true_area +
  (difference - (first - second)) / true_area + 1 { true_area <> 0 };
missing_part_first / true_area -> -((first - true_first) / true_area) { true_area <> 0 };
missing_part_second / true_area -> -((second - true_second) / true_area) { true_area <> 0 };
