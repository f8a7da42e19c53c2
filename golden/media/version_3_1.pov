// The defaults of version 3.1, but for the method: ten intervals of one sample each.
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 45 }
plane { -z, -3 pigment { rgb <0.5, 0.3, 0.2> } finish { ambient 1 diffuse 0 } }
light_source { <3, 4, -3> rgb 1 }
sphere { 0, 1.2 hollow pigment { rgbt 1 }
  interior { media { method 2 scattering { 1, 0.3 } emission <0.05, 0.1, 0.3>
    density { onion color_map { [0 rgb 0.2] [1 rgb 1.5] } scale 0.5 } } } }
