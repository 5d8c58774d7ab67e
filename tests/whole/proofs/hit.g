#: at most 23 e M: hit, beside its triangle
# P is the mean of the true corners by the shares a, b, c of the sheared ones, in lengths of M: x along an axis and z
# along the main one. slope is the direction's component by its longest, and way is t times that longest. The sheared
# corners weigh to exactly 0.

x = a * x_p + b * x_q + c * x_r;
z = a * z_p + b * z_q + c * z_r;
error_p = sheared_p - (x_p - slope * z_p);
error_q = sheared_q - (x_q - slope * z_q);
error_r = sheared_r - (x_r - slope * z_r);
beside_p = a + a * error_p;
beside_q = b + b * error_q;
beside_r = c + c * error_r;

{
  a in [1b-400, 1] /\
  b in [1b-400, 1] /\
  c in [1b-400, 1] /\
  a + b in [1b-400, 1] /\
  a + b + c in [1, 1] /\
  a / (a + b) in [0, 1] /\
  (a + b) / (a + b + c) in [0, 1] /\
  a * sheared_p + b * sheared_q + c * sheared_r in [0, 0] /\
  |slope| <= 1 /\
  |error_p| <= {sheared_corner} /\
  |error_q| <= {sheared_corner} /\
  |error_r| <= {sheared_corner} /\
  |way - z| <= {distance}
  -> slope * way - x in ? /\ way - z in ?
}

(beside_p - a) / a -> error_p { a <> 0 };
(beside_q - b) / b -> error_q { b <> 0 };
(beside_r - c) / c -> error_r { c <> 0 };
slope * way - x -> slope * (way - z) +
  (((beside_p + beside_q + beside_r) - (a + b + c)) - (a * sheared_p + b * sheared_q + c * sheared_r));
