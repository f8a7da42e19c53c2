// uv_mapping after the texture it should hold for.
sphere { 0, 1 texture { pigment { checker } } uv_mapping }
