// The whole scene is a thousandth of its size, written as an object that is scaled.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.001, -0.004> look_at 0 angle 45 }
background { rgb <0.3, 0.4, 0.5> }
#declare Cloud = sphere { 0, 1 hollow pigment { rgbt 1 }
  interior { media { emission <500, 350, 100> absorption 700 samples 12 density { spherical color_map { [0 rgb 0] [1 rgb 2] } } } } }
object { Cloud scale 0.001 }
plane { -z, -0.003 pigment { rgb <0.2, 0.4, 0.7> } finish { ambient 1 diffuse 0 } }
