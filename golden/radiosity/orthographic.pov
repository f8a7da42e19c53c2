// Parallel rays of the camera.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { error_bound 1.2 pretrace_end 0.02 } }

camera { orthographic location <3, 4, -5> look_at <0, 0.5, 0> right 4*x up 3*y }
light_source { <5, 8, -3>, rgb 0.7 }
background { rgb <0.4, 0.5, 0.7> }
plane { y, 0 pigment { checker rgb <0.9, 0.5, 0.3> rgb 0.8 } finish { diffuse 0.8 } }
difference { box { <-1, 0, -1>, <1, 1.2, 1> } box { <-0.8, 0.2, -1.1>, <0.8, 1.3, 0.8> } pigment { rgb 0.9 } finish { diffuse 0.8 } }
