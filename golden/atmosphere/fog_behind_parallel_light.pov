// Behind the plane of a parallel light that fog dims, its light is that without fog.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 8, -9> look_at <0, 2.5, 0> angle 40 }
light_source { <0, 1, 0>, rgb 0.7 parallel point_at <0.1, 0, 0.2> media_attenuation on }
fog { distance 5 rgbf <0.3, 0.35, 0.45, 0.3> }
sphere { <0, 4, 0>, 1.5 pigment { rgb <0.9, 0.6, 0.3> } }
sphere { <-2, 1.2, -1>, 1 pigment { rgb <0.4, 0.8, 0.3> } }
plane { y, 0 pigment { rgb 0.8 } }
