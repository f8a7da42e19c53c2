// omnimax camera.
#version 3.7;
global_settings { assumed_gamma 1.0 }

light_source { <0, 2, -1> rgb 1 }
box { <-3, -2, -4>, <3, 3, 4> pigment { checker rgb <0.9, 0.85, 0.8> rgb <0.4, 0.5, 0.6> scale 0.7 translate 0.03 } }
sphere { <-1, -0.4, 2.5>, 0.8 pigment { rgb <0.8, 0.3, 0.2> } }
cylinder { <1.4, -2, 2>, <1.4, 3, 2>, 0.3 pigment { rgb <0.9, 0.8, 0.3> } }
torus { 0.5, 0.15 rotate 90 * x translate <0.2, 0.9, 2.5> pigment { rgb <0.3, 0.7, 0.3> } }

camera { omnimax location 0 look_at <0.2, 0.3, 1> angle 160 }
