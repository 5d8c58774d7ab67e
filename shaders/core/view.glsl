// The rectangle that a picture looks through, one length of the view direction before the eye.
// The point at (s, t) of it, each from 0 to 1, lies at eye + lower_left + s * right + t * up.
struct View {
    real3 eye;
    real3 lower_left;
    real3 right;
    real3 up;
};
