// A ball of two kinds of cloud: a density_map chooses between marble and bozo, and a second density thins the rim.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 angle 40 }
background { rgb <0.1, 0.15, 0.25> }
plane { y, -1.2 pigment { checker rgb 0.8 rgb 0.3 } finish { ambient 0.2 diffuse 0.6 } }
light_source { <3, 5, -4> rgb 1 }
sphere { 0, 1.1 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
  interior { media {
    emission <0.9, 0.6, 0.3> absorption <0.4, 0.7, 1.2> samples 24 aa_level 4
    density { gradient y density_map {
      [0.3 marble turbulence 0.4 color_map { [0 rgb 0] [0.6 rgb 1.5] [1 rgb 0.2] } scale 0.5]
      [0.7 bozo color_map { [0.3 rgb 0] [0.7 rgb <1, 2, 1>] } scale 0.3]
    } scale 2 translate -y }
    density { spherical color_map { [0 rgb 0] [0.4 rgb 1] } }
  } } }
