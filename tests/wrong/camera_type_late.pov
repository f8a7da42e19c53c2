// The camera's type must come first.
camera { location -5 * z look_at 0 fisheye angle 150 }
sphere { 0, 1 pigment { rgb 1 } }
