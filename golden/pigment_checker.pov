// checker: two colours, two pigments, and turned and scaled on different bodies.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.2, 0.4> rotate 30 * y scale 0.7 } }
sphere { <-1.2, 0, 0>, 1 pigment { checker rgb <0.9, 0.7, 0.2> rgb <0.2, 0.3, 0.6> scale 0.35 translate 0.1 } }
box { <0.3, -0.9, -0.8>, <1.9, 0.8, 0.8> rotate 15 * y
  pigment { checker pigment { rgb <0.8, 0.3, 0.2> } pigment { checker rgb 1 rgb 0 scale 0.2 } scale 0.5 translate 0.13 } }
