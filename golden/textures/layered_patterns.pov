// Layered textures: patterned layers with filter and transmit over one another, each with its own finish.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 40 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.3, 0.35, 0.4> }
#declare Ghost = texture { pigment { bozo color_map { [0 rgbt 1] [0.4 rgbt 1] [0.6 rgbt <0.2, 0.5, 0.2, 0.2>] [1 rgbf <0.1, 0.3, 0.1, 0.6>] } scale 0.3 } finish { specular 0.5 } }
sphere { -1.3 * x, 1.1 texture { pigment { wood color_map { [0 rgb <0.8, 0.6, 0.4>] [1 rgb <0.5, 0.3, 0.1>] } scale 0.3 rotate 80 * y } } texture { Ghost } }
box { -0.8, 0.8 rotate <25, 35, 0> translate 1.3 * x texture { pigment { rgbf <0.9, 0.9, 1, 0.5> } } texture { Ghost } texture { pigment { gradient x color_map { [0.7 rgbt 1] [0.7 rgbt <0.8, 0.1, 0.1, 0.1>] } scale 0.41 } } }
