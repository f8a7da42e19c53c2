// reflection: plain colour, min and max, falloff, exponent, metallic, fresnel, conserve_energy.
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

Ball(finish { reflection rgb <0.9, 0.5, 0.3> diffuse 0.2 })
Ball(finish { reflection { 0.1, 0.9 falloff 3 } })
Ball(finish { reflection { 0.5 exponent 0.5 } })
Ball(finish { reflection { 0.3, 0.8 metallic } diffuse 0.3 })
Bead(material { texture { pigment { rgb <0.7, 0.5, 0.3> } finish { reflection { 0, 1 fresnel } } } interior { ior 1.8 } })
Bead(material { texture { pigment { rgbt <0.9, 0.8, 0.7, 0.6> } finish { reflection { 0.1, 0.8 fresnel } conserve_energy } } interior { ior 1.5 } })
