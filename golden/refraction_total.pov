// refraction: glass bodies, seen from outside and with total internal reflection in the prism.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8> rgb <0.1, 0.3, 0.5> scale 0.5 } }
plane { z, 6 pigment { gradient x color_map { [0 rgb <0.9, 0.3, 0.1>] [1 rgb <0.9, 0.9, 0.3>] } } }

#declare Glass = texture { pigment { rgbf <1, 1, 1, 0.9> } finish { phong 0.5 } }
sphere { <-1.5, 0, 0>, 0.9 texture { Glass } interior { ior 1.5 } }
intersection {
  plane { -y, 0.8 } plane { <1, 1, 0>, 0.3 } plane { <-1, 1, 0>, 0.3 } plane { -z, 0.8 } plane { z, 0.8 }
  rotate 35 * y
  translate <1.1, -0.1, 0>
  texture { Glass }
  interior { ior 1.6 }
}
