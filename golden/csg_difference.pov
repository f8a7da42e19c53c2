// difference: drilled holes, several at once, each wall with the texture of what cut it.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2, -6> look_at 0 angle 38 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

difference {
  box { -1, 1 }
  cylinder { -2 * z, 2 * z, 0.6 pigment { rgb <0.9, 0.8, 0.3> } }
  cylinder { -2 * x, 2 * x, 0.4 pigment { rgb <0.3, 0.7, 0.3> } }
  sphere { <-1, 1, -1>, 0.7 pigment { rgb <0.3, 0.4, 0.9> } }
  rotate <0, 35, 0>
  pigment { rgb <0.8, 0.3, 0.2> }
}
