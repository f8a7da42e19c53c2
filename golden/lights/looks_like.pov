// looks_like: lamps that are seen and cast no shadow, carried along by the light's transforms.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 4.5, -7> look_at <0, 0.2, 0.3> angle 44 }
plane { y, 0 pigment { rgb 0.85 } }
sphere { <-1.2, 0.5, 0.4>, 0.5 pigment { rgb <0.9, 0.8, 0.7> } finish { phong 0.5 } }
cylinder { <0.1, 0, 0.2>, <0.1, 1, 0.2>, 0.25 pigment { rgb <0.8, 0.5, 0.3> } }
box { <1.1, 0, 0>, <1.8, 0.8, 0.8> pigment { rgb <0.5, 0.6, 0.8> } }

light_source { <-1.6, 2, -0.5> rgb <1, 0.8, 0.5> looks_like { sphere { 0, 0.25 pigment { rgb <1, 0.9, 0.6> } finish { emission 1 diffuse 0 } } } }
light_source { 0 rgb <0.3, 0.4, 0.8> looks_like { box { -0.2, 0.2 rotate 45 pigment { rgb <0.5, 0.6, 1> } finish { emission 1 } } } translate <1.8, 1.8, 0.3> }
