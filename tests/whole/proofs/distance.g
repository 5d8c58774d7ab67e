#: at most 17 e M: t, times the direction
# Against the mean of the true z by the exact shares a, b, c. No true z is greater than the unit, which is M by the
# direction's longest component. A share that is 0 is exact, and its term falls away.

@rnd = float<24, ne>;
t rnd= {shaders/triangle/watertight/shear.glsl watertight_hit t};
true_p = part_p * unit;
true_q = part_q * unit;
true_r = part_r * unit;
true_t = a * true_p + b * true_q + c * true_r;

# The sum as it grows.
term_a = rnd(share * p_z);
term_b = rnd(u * q_z);
term_c = rnd(v * r_z);
error_a = (term_a - a * true_p) / unit;
error_b = (term_b - b * true_q) / unit;
error_c = (term_c - c * true_r) / unit;
two_terms = term_a + term_b;

# Errors of terms have any sign. Beside their shares they are parts of numbers of one sign, so their sum is no greater
# a part of the shares' sum, which is 1. The same for the terms themselves, by half to keep the sign.
beside_a = a + error_a;
beside_b = b + error_b;
beside_c = c + error_c;
half_a = a + a * part_p / 2;
half_b = b + b * part_q / 2;
half_c = c + c * part_r / 2;

{
  unit in [1b-200, 1b200] /\
  a in [1b-400, 1] /\
  b in [1b-400, 1] /\
  c in [1b-400, 1] /\
  a + b in [1b-400, 1] /\
  a + b + c in [1, 1] /\
  a / (a + b) in [0, 1] /\
  (a + b) / (a + b + c) in [0, 1] /\
  |part_p| <= 1 /\
  |part_q| <= 1 /\
  |part_r| <= 1 /\
  |share -/ a| <= {share} /\
  |u -/ b| <= {share} /\
  |v -/ c| <= {share} /\
  |p_z -/ true_p| <= {sheared_depth} /\
  |q_z -/ true_q| <= {sheared_depth} /\
  |r_z -/ true_r| <= {sheared_depth}
  -> (t - true_t) / unit in ?
}

(beside_a - a) / a -> (term_a - a * true_p) / (a * unit) { a <> 0, unit <> 0, a * unit <> 0 };
(beside_b - b) / b -> (term_b - b * true_q) / (b * unit) { b <> 0, unit <> 0, b * unit <> 0 };
(beside_c - c) / c -> (term_c - c * true_r) / (c * unit) { c <> 0, unit <> 0, c * unit <> 0 };
(a * true_p) / (a * unit) -> part_p { a * unit <> 0, a <> 0, unit <> 0 };
(b * true_q) / (b * unit) -> part_q { b * unit <> 0, b <> 0, unit <> 0 };
(c * true_r) / (c * unit) -> part_r { c * unit <> 0, c <> 0, unit <> 0 };
(half_a - a) / a -> part_p / 2 { a <> 0 };
(half_b - b) / b -> part_q / 2 { b <> 0 };
(half_c - c) / c -> part_r / 2 { c <> 0 };
error_a + error_b -> (beside_a + beside_b) - (a + b) { unit <> 0 };
error_a + error_b + error_c -> (beside_a + beside_b + beside_c) - (a + b + c) { unit <> 0 };
two_terms / unit -> ((half_a + half_b) - (a + b)) * 2 + (error_a + error_b) { unit <> 0 };
(rnd(two_terms) + term_c) / unit ->
  ((half_a + half_b + half_c) - (a + b + c)) * 2 + (error_a + error_b + error_c) +
  (rnd(two_terms) - two_terms) / unit { unit <> 0 };
(t - true_t) / unit ->
  (t - (rnd(two_terms) + term_c)) / unit + (rnd(two_terms) - two_terms) / unit +
  (error_a + error_b + error_c) { unit <> 0 };
