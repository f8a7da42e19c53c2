// An open place under a sky that is all the light there is.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 100 error_bound 1 } }

camera { location <0, 3, -7> look_at <0, 0.6, 0> right 4/3*x up y angle 45 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.7, 0.5>] [1 rgb <0.3, 0.5, 1>] } } }
plane { y, 0 pigment { rgb 0.8 } finish { diffuse 0.8 } }
sphere { <-1.2, 1, 0>, 1 pigment { rgb <0.9, 0.4, 0.3> } finish { diffuse 0.8 } }
box { <0.3, 0, -0.7>, <1.7, 1.4, 0.7> pigment { rgb 0.9 } finish { diffuse 0.8 } rotate y * 25 }
torus { 0.5, 0.2 pigment { rgb <0.4, 0.8, 0.5> } finish { diffuse 0.8 } translate <0.2, 0.2, -1.9> }
