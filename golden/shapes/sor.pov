// sor: closed, open, and cut in half.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

sor { 6, <0, -1.3>, <0.4, -1>, <0.9, -0.2>, <0.3, 0.6>, <0.5, 1>, <0.6, 1.2> translate -2 * x pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 } }
sor { 5, <0.3, -1.4>, <0.7, -0.8>, <0.5, 0>, <0.9, 0.8>, <1, 1.1> open rotate -20 * x pigment { rgb <0.3, 0.7, 0.3> } }
difference {
  sor { 5, <0.2, -1.2>, <0.5, -0.8>, <0.8, 0.1>, <0.3, 0.8>, <0, 1.1> }
  plane { <-0.3, 0, 1>, -0.1 pigment { rgb <0.9, 0.8, 0.3> } }
  translate 2 * x
  pigment { rgb <0.3, 0.4, 0.9> }
}
