// finish: phong of several sizes, specular of several roughnesses.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb <1, 0.95, 0.9> }
background { rgb <0.1, 0.12, 0.2> }

#for (K, 0, 2)
  sphere { <2 * K - 2, 1, 0>, 0.9 pigment { rgb <0.6, 0.2, 0.2> } finish { phong 0.9 phong_size pow(5, K + 1) } }
  sphere { <2 * K - 2, -1, 0>, 0.9 pigment { rgb <0.2, 0.3, 0.6> } finish { specular 0.9 roughness pow(0.1, K + 0.5) } }
#end
