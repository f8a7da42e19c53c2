// A unit of one millimetre: a ball of wax that a lamp behind it shines through.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 1 subsurface { samples 200, 60 } }
camera { location <0, 0, -4> look_at 0 right 4/3*x up y angle 40 }
light_source { <4, 5, 6>, rgb <1, 0.9, 0.8> }
light_source { <-5, 1, -6>, rgb 0.2 }
sphere { 0, 1
  pigment { rgb <0.8, 0.55, 0.3> } interior { ior 1.4 }
  finish { ambient 0 diffuse 0.7 subsurface { translucency <2, 1, 0.5> } }
}
