GIF89a is not a scene, and neither is this sentence.
