// finish: brilliance sharpens or flattens the diffuse fall-off; albedo keeps the amount.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#for (K, 0, 2)
  sphere { <2 * K - 2, 1, 0>, 0.9 pigment { rgb <0.3, 0.7, 0.4> } finish { brilliance 0.5 + 2 * K } }
  sphere { <2 * K - 2, -1, 0>, 0.9 pigment { rgb <0.3, 0.7, 0.4> } finish { diffuse albedo 0.7 brilliance 0.5 + 2 * K } }
#end
