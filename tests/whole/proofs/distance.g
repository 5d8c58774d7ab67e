#: at most 17 e M: t, times the direction
# Against the mean of the true z by the exact shares a, b, c. The unit is M by the direction's longest component, so each
# true z is at most 1. A share that is 0 is exact, and its term falls away.

@rnd = float<24, ne>;
t rnd= {shaders/triangle/watertight/shear.glsl watertight_hit t};
true_t = a * true_p + b * true_q + c * true_r;

# The sum as it grows.
term_a = rnd(share * p_z);
term_b = rnd(u * q_z);
term_c = rnd(v * r_z);
error_a = term_a - a * true_p;
error_b = term_b - b * true_q;
error_c = term_c - c * true_r;
two_terms = term_a + term_b;

# Errors of terms have any sign. Beside their shares they are parts of numbers of one sign, so their sum is no greater
# a part of the shares' sum, which is 1. The same for the terms themselves, by half to keep the sign.
beside_a = a + error_a;
beside_b = b + error_b;
beside_c = c + error_c;
half_a = a + a * true_p / 2;
half_b = b + b * true_q / 2;
half_c = c + c * true_r / 2;

{
  a in [1b-400, 1] /\
  b in [1b-400, 1] /\
  c in [1b-400, 1] /\
  a + b in [1b-400, 1] /\
  a + b + c in [1, 1] /\
  a / (a + b) in [0, 1] /\
  (a + b) / (a + b + c) in [0, 1] /\
  |true_p| <= 1 /\
  |true_q| <= 1 /\
  |true_r| <= 1 /\
  |share -/ a| <= {share} /\
  |u -/ b| <= {share} /\
  |v -/ c| <= {share} /\
  |p_z -/ true_p| <= {sheared_depth} /\
  |q_z -/ true_q| <= {sheared_depth} /\
  |r_z -/ true_r| <= {sheared_depth}
  -> t - true_t in ?
}

(beside_a - a) / a -> error_a / a { a <> 0 };
(beside_b - b) / b -> error_b / b { b <> 0 };
(beside_c - c) / c -> error_c / c { c <> 0 };
(half_a - a) / a -> true_p / 2 { a <> 0 };
(half_b - b) / b -> true_q / 2 { b <> 0 };
(half_c - c) / c -> true_r / 2 { c <> 0 };
error_a + error_b -> (beside_a + beside_b) - (a + b);
error_a + error_b + error_c -> (beside_a + beside_b + beside_c) - (a + b + c);
a * true_p + b * true_q -> ((half_a + half_b) - (a + b)) * 2;
true_t -> ((half_a + half_b + half_c) - (a + b + c)) * 2;
two_terms -> (a * true_p + b * true_q) + (error_a + error_b);
rnd(two_terms) + term_c -> true_t + (error_a + error_b + error_c) + (rnd(two_terms) - two_terms);
t - true_t ->
  (t - (rnd(two_terms) + term_c)) + (rnd(two_terms) - two_terms) + (error_a + error_b + error_c);
