## Labels and tooltips of parameters. English tooltips come from the descriptions in the code.

param-key = In scene files: { $key }

# Everything that has a place.
param-visible = Show
param-position = Place
param-turn_deg = Turn
    .tooltip = How it is turned about the world's X axis, then Y, then Z, through its centre.
param-scale = Size
param-material = Material
param-group = Group

# Shapes.
param-radius = Radius
param-disc-radius = Disc radius
param-box-size = Edges
param-points = Corner
    .tooltip = The corner before the object is moved, turned or scaled.
param-uvs = Picture at the corners
param-file = File
param-smooth = Smooth

# Lights.
param-intensity = Brightness
param-light-color = Colour
param-direction = Direction

# The camera.
param-camera-position = Camera place
param-camera-turn_deg = Turn
    .tooltip = How the camera is turned about the world's X axis, then Y, then Z, through itself.
param-look_at = Look at
    .tooltip = The point that it looks at, the picture's middle; Y stays up.
param-view_angle_deg = Zoom angle

# Materials.
param-color = Colour
param-texture = Picture on surface
param-diffuse = Matte amount (diffuse)
param-specular = Highlight (specular)
param-shininess = Highlight size (shininess)
param-reflectivity = Mirror (reflectivity)
param-transparency = Transparency
param-refraction = Light bending (index)
param-base_weight = Base amount
param-base_color = Base colour
param-base_metalness = Metal
param-specular_weight = Surface reflection
param-specular_roughness = Frosting
    .tooltip = How rough the surface is: 0 is polished, 1 is dull; glass becomes frosted.
param-specular_ior = Index of refraction
param-transmission_weight = Light let through
param-transmission_color = Tint inside
param-transmission_depth = Tint depth
param-geometry_thin_walled = Thin pane

# Textures.
param-repeat = Repeats
param-shift = Shift
param-wrap = Beyond the edges
param-other_color = Other colour

# The picture.
param-settings-size = Picture size
param-renderer = Method
param-depth = Reflection depth
param-samples = Quality (rays per pixel)
param-shadow_points = Shadow points
param-shadow_error = Shadow grain
param-background = Background
param-seed = Random number
