// triangle: flat and smooth, each seen from both sides.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0.5, -6> look_at 0 angle 42 }
light_source { <-5, 6, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

triangle { <-2.2, -1, 0>, <-0.4, -0.8, 0.4>, <-1.3, 0.9, 0> pigment { rgb <0.8, 0.3, 0.2> } }
smooth_triangle { <0.3, -1, 0>, <-0.5, -0.3, -1>, <2.1, -0.8, 0>, <0.6, -0.2, -1>, <1.3, 1.1, 0>, <0, 0.8, -1>
  pigment { rgb <0.3, 0.7, 0.3> } finish { phong 0.6 } }
triangle { <-0.4, 1.4, 0.5>, <0.7, 1.5, -0.6>, <0.1, 0.6, -0.2> pigment { rgb <0.3, 0.4, 0.9> } }
