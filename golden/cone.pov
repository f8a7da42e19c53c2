// cone: pointed, truncated, open, widening upwards.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

cone { <-1.9, -1, 0>, 0.8, <-1.9, 1.2, 0>, 0 pigment { rgb <0.8, 0.3, 0.2> } }
cone { <0, -1, 0>, 0.7, <0.1, 0.7, 0>, 0.35 open pigment { rgb <0.3, 0.7, 0.3> } }
cone { <1.7, -1, -0.4>, 0.2, <2, 1, 0.5>, 0.8 pigment { rgb <0.3, 0.4, 0.9> } finish { phong 0.8 } }
