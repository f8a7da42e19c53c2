// A surface's own light fades with filter and transmit; highlights stay; ambient and emission under glass.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 0, -8> look_at 0 angle 40 }
light_source { <-5, 6, -8> rgb <1, 0.95, 0.9> }
background { rgb <0.4, 0.5, 0.7> }
plane { y, -2.2 pigment { checker rgb 0.9 rgb 0.2 translate 0.1 } }
#declare N = 0;
#macro Next() translate <mod(N, 3) * 2 - 2, 1 - 2 * int(N / 3), 0> #declare N = N + 1; #end
#macro Ball(F) sphere { 0, 0.9 pigment { rgb <0.7, 0.4, 0.3> } finish { F } Next() } #end
#macro Bead(M) sphere { 0, 0.9 material { M } Next() } #end

Bead(material { texture { pigment { rgbf <0.9, 0.6, 0.3, 0.7> } finish { phong 0.8 } } })
Bead(material { texture { pigment { rgbt <0.9, 0.6, 0.3, 0.7> } finish { phong 0.8 } } })
Bead(material { texture { pigment { rgbft <0.9, 0.6, 0.3, 0.4, 0.4> } finish { specular 0.8 metallic } } })
Bead(material { texture { pigment { rgbf <0.9, 0.6, 0.3, 0.9> } finish { emission 0.3 ambient 0.4 } } })
Bead(material { texture { pigment { rgbt <0.3, 0.6, 0.9, 1> } finish { reflection 0.3 } } })
Bead(material { texture { pigment { rgbft <0.3, 0.6, 0.9, 0.5, 0.3> } } interior { ior 1.3 } })
