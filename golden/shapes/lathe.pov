// lathe: all four splines.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

lathe { linear_spline 5, <0.1, -0.8>, <0.8, -0.6>, <0.3, 0>, <0.7, 0.5>, <0.5, 0.8> translate <-1.5, 1.1, 0> pigment { rgb <0.8, 0.3, 0.2> } }
lathe { quadratic_spline 6, <0, -1>, <0.1, -0.8>, <0.8, -0.5>, <0.3, 0>, <0.6, 0.5>, <0.4, 0.8> translate <1.5, 1.1, 0> pigment { rgb <0.3, 0.7, 0.3> } }
lathe { cubic_spline 7, <0, -1>, <0.1, -0.8>, <0.8, -0.5>, <0.3, 0>, <0.6, 0.5>, <0.4, 0.8>, <0.3, 1> rotate 30 * x translate <-1.5, -1.1, 0> pigment { rgb <0.3, 0.4, 0.9> } finish { phong 0.5 } }
lathe { bezier_spline 8, <0.1, -0.8>, <0.9, -0.9>, <0.9, -0.2>, <0.4, 0>, <0.4, 0>, <0.2, 0.2>, <0.9, 0.4>, <0.5, 0.8> sturm rotate <20, 0, 15> translate <1.5, -1.1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
