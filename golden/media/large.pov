// A cloud a thousand times as large, with a density per unit that is so much less, lit and in its own shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 800, -4500> look_at 0 angle 40 }
light_source { <5000, 6000, -3000> rgb 1.5 }
plane { y, -1100 pigment { rgb <0.5, 0.5, 0.4> } }
plane { -z, -6000 pigment { rgb <0.3, 0.4, 0.6> } finish { ambient 1 diffuse 0 } }
#declare Cloud = sphere { 0, 1 hollow pigment { rgbt 1 }
  interior { media { scattering { 1, 0.0012 } intervals 2 samples 8
    density { spherical color_map { [0 rgb 0] [0.6 rgb 1] } } density { bumps scale 0.3 color_map { [0.2 rgb 0] [0.7 rgb 1.4] } } } } }
object { Cloud scale 1000 }
