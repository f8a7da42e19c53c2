// Antialiasing method 1 with POV-Ray's own threshold and depth, without jitter.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.5> scale 0.6 } }
sphere { -0.8 * x, 1 pigment { rgb <0.8, 0.3, 0.2> } finish { reflection 0.3 } }
torus { 0.8, 0.08 rotate <70, 20, 0> translate 1.2 * x pigment { rgb <0.9, 0.8, 0.3> } }
