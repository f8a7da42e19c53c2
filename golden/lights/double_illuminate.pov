// double_illuminate and back-side diffuse: thin sheets lit from behind.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 2, -6> look_at <0, 0.6, 0> angle 40 }
background { rgb <0.1, 0.12, 0.2> }
light_source { <1, 3, 4> rgb 1 }
plane { y, -0.4 pigment { rgb <0.7, 0.7, 0.6> } }
disc { <-1.8, 0.7, 0>, z, 0.8 pigment { rgb <0.9, 0.3, 0.2> } }
disc { <0, 0.7, 0>, z, 0.8 pigment { rgb <0.9, 0.3, 0.2> } double_illuminate }
disc { <1.8, 0.7, 0>, z, 0.8 pigment { rgb <0.9, 0.3, 0.2> } finish { diffuse 0.6, 0.4 } }
