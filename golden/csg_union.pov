// union: inherits texture and transforms, parts may have their own; unions in unions.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2, -7> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

union {
  sphere { -1.2 * x, 0.7 }
  box { <-0.4, -0.4, -0.4>, 0.4 pigment { rgb <0.3, 0.7, 0.3> } }
  union {
    cylinder { -0.6 * y, 0.6 * y, 0.3 }
    cone { 0.6 * y, 0.5, 1.2 * y, 0 pigment { rgb <0.9, 0.8, 0.3> } }
    rotate -30 * z
    translate 1.3 * x
    pigment { rgb <0.3, 0.4, 0.9> }
  }
  rotate 15 * y
  pigment { rgb <0.8, 0.3, 0.2> }
}
