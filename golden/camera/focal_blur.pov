// Focal blur: aperture, focal_point, blur_samples.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -6> look_at 0 angle 40 aperture 0.5 focal_point <0, 0, 0> blur_samples 19 confidence 0.9 variance 1/1000 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.2, 0.25, 0.35> }
plane { y, -0.8 pigment { rgb <0.6, 0.55, 0.5> } }
sphere { <-1.6, -0.1, -2>, 0.7 pigment { rgb <0.8, 0.3, 0.2> } }
sphere { 0, 0.7 pigment { rgb <0.3, 0.7, 0.3> } }
sphere { <2, 0.2, 3>, 0.9 pigment { rgb <0.3, 0.4, 0.9> } }
