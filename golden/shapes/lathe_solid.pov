// lathe as a solid: closed profiles in a difference and an intersection, uv_mapping on a third.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

difference {
  lathe { linear_spline 5, <0.4, -0.7>, <1, -0.5>, <0.9, 0.5>, <0.5, 0.7>, <0.4, -0.7> }
  box { <0, -2, -2>, <2, 2, 0> pigment { rgb <0.9, 0.8, 0.3> } }
  rotate 20 * x
  translate -1.5 * x
  pigment { rgb <0.8, 0.3, 0.2> }
}
lathe { cubic_spline 6, <0, -1.3>, <0.5, -0.9>, <0.8, -0.2>, <0.4, 0.5>, <0.6, 0.9>, <0.7, 1.2> rotate 15 * x translate 1.4 * x
  uv_mapping pigment { checker rgb 1 rgb <0.2, 0.4, 0.8> scale 0.125 translate 0.01 } }
