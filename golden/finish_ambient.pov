// finish: ambient with ambient_light, emission, and both on an unlit body.
#version 3.7;
global_settings { assumed_gamma 1.0 ambient_light rgb <1, 0.8, 0.6> }

camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb 0.6 }

#for (K, 0, 2)
  sphere { <2 * K - 2, 1, 0>, 0.9 pigment { rgb <0.5, 0.6, 0.9> } finish { ambient 0.3 * K } }
  sphere { <2 * K - 2, -1, 0>, 0.9 pigment { rgb <0.5, 0.6, 0.9> } finish { ambient rgb <0.1, 0.3, 0> emission 0.4 * K diffuse 0.2 } }
#end
