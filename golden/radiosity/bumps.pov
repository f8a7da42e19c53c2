// Samples about a bumpy normal.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { normal on count 100 nearest_count 8 } }

camera { location <0, 3, -5> look_at <0, 0.4, 0> right 4/3*x up y angle 45 }
sky_sphere { pigment { gradient x color_map { [0 rgb 0.1] [0.5 rgb 0.6] [1 rgb <1, 0.9, 0.8>] } scale 2 translate -x } }
plane { y, 0 pigment { rgb 0.8 } normal { gradient x 0.4 sine_wave scale 0.8 } finish { diffuse 0.8 } }
sphere { <0, 0.9, 0>, 0.9 pigment { rgb 0.9 } finish { diffuse 0.8 } }
