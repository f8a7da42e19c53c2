// parametric: a twisted band and a wavy sphere, with uv_mapping on one.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

parametric {
  function { (1 + 0.4 * v * cos(u / 2)) * cos(u) } function { 0.4 * v * sin(u / 2) } function { (1 + 0.4 * v * cos(u / 2)) * sin(u) }
  <0, -1>, <2 * pi, 1> contained_by { box { -1.5, 1.5 } } accuracy 0.002 max_gradient 2 precompute 10, x, y, z
  rotate -50 * x translate -1.5 * x pigment { rgb <0.8, 0.5, 0.2> }
}
parametric {
  function { cos(u) * cos(v) } function { sin(v) * (1 + 0.15 * sin(4 * u)) } function { sin(u) * cos(v) }
  <0, -pi / 2>, <2 * pi, pi / 2> contained_by { sphere { 0, 1.3 } } accuracy 0.002 max_gradient 2 precompute 10, x, y, z
  translate 1.6 * x uv_mapping pigment { gradient x color_map { [0 rgb <0.2, 0.4, 0.9>] [1 rgb 1] } scale 1.03 }
}
