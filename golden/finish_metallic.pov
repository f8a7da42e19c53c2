// finish: metallic highlights and reflections take the colour of the surface.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb 1 }
background { rgb <0.5, 0.6, 0.8> }
plane { y, -2 pigment { checker rgb 1 rgb 0.3 } }

#for (K, 0, 2)
  sphere { <2 * K - 2, 1, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { specular 0.8 roughness 0.02 metallic K / 2 } }
  sphere { <2 * K - 2, -1, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { diffuse 0.2 phong 0.7 metallic reflection { 0.2, 0.6 metallic K / 2 } } }
#end
