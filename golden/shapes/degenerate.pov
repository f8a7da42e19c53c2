// Degenerate input is dropped: flat triangles, a box without depth, a cone that is a cylinder, a scale by nearly zero.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

cone { <-1.8, -0.8, 0>, 0.5, <-1.8, 0.8, 0>, 0.5 pigment { rgb <0.8, 0.3, 0.2> } }
box { <-0.7, -0.7, 0>, <0.7, 0.7, 0> pigment { rgb <0.3, 0.7, 0.3> } }
mesh {
  triangle { <1, -1, 0>, <1, -1, 0>, <2, 1, 0> }
  triangle { <1, -0.8, 0>, <2.4, -0.6, 0>, <1.8, 0.9, 0> }
  pigment { rgb <0.9, 0.8, 0.3> }
}
cylinder { <0.2, -1.3, 0>, <1.8, -1.3, 0>, 0.2 scale <1, 1, 0.001> pigment { rgb <0.3, 0.4, 0.9> } }
