// trace() passed by what casts no shadow, so that both ends of the cylinder were the same point.
#version 3.7;
#declare Ground = box { -1, 1 no_shadow }
#declare Normal = <0, 0, 0>;
#declare Hit = trace(Ground, 3 * y, -y, Normal);
cylinder { Hit, Hit + Normal, 0.1 }
