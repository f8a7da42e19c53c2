// merge: transparent sphere, cone, torus and box as one body; and a merge used as a subtrahend.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.2, -6> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
plane { z, 4 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.5> translate 0.1 } }
merge {
  sphere { 0, 0.7 } cone { -0.9 * y, 0.5, 1.1 * y, 0.1 } torus { 0.7, 0.2 rotate 20 * x } box { <-1, -0.2, -0.2>, <1, 0.2, 0.2> }
  translate -1.4 * x
  pigment { rgbt <0.9, 0.7, 0.4, 0.6> }
  finish { phong 0.5 }
}
difference {
  box { -0.9, 0.9 }
  merge { cylinder { -2 * z, 2 * z, 0.5 } cylinder { -2 * y, 2 * y, 0.5 } pigment { rgb <0.9, 0.8, 0.3> } }
  rotate <20, 30, 0>
  translate 1.4 * x
  pigment { rgb <0.3, 0.6, 0.4> }
}
