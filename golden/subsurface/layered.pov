// Layers: a stained glaze over a stone, a veil over paint, and a pattern that chooses between both.
#version 3.7;
global_settings { assumed_gamma 1 subsurface { samples 150, 30 } }
camera { location <0, 1, -6> look_at 0 right 4/3*x up y angle 40 }
light_source { <5, 6, -8>, rgb 0.8 }
#declare Stone = texture {
  pigment { rgb <0.8, 0.75, 0.6> }
  finish { ambient 0 diffuse 0.8 subsurface { translucency 1 } }
}
#declare Stain = texture { pigment { gradient y color_map { [0 rgbt <0.5, 0.1, 0.1, 0.2>] [1 rgbt 1] } scale 0.5 } finish { ambient 0.1 diffuse 0.6 } }
#declare Veil = texture { pigment { rgbf <0.6, 0.8, 1, 0.7> } finish { ambient 0 diffuse 0.6 subsurface { translucency 0.5 } } }
sphere { <-1.5, 0, 0>, 0.7 texture { Stone } texture { Stain } interior { ior 1.4 } }
sphere { <0, 0, 0>, 0.7 texture { pigment { rgb <0.2, 0.5, 0.3> } } texture { Veil } interior { ior 1.2 } }
sphere { <1.5, 0, 0>, 0.7 texture { bozo scale 0.3 texture_map { [0.4 Stone] [0.6 pigment { rgb <0.3, 0.3, 0.8> } finish { ambient 0.05 }] } } interior { ior 1.4 } }
