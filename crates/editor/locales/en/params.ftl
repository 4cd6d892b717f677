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
param-temperature = Colour temperature
param-full_at = Distance of full brightness
param-environment-file = Panorama
param-environment-turn_deg = Turn
    .tooltip = How far the panorama is turned about the Y axis.
param-sun_elevation_deg = Height of the sun
param-sun_azimuth_deg = Direction of the sun
param-turbidity = Haze
param-sun = Sun

# The camera.
param-camera-position = Camera place
param-camera-turn_deg = Turn
    .tooltip = How the camera is turned about the world's X axis, then Y, then Z, through itself.
param-look_at = Look at
    .tooltip = The point that it looks at, the picture's middle; Y stays up.
param-view_angle_deg = Zoom angle
param-focus_distance = Focus distance
param-f_stop = Aperture (f-number)
param-blades = Aperture blades

# Materials.
param-color = Colour
param-texture = Picture on surface
param-diffuse = Matte amount (diffuse)
param-specular = Highlight (specular)
param-shininess = Highlight size (shininess)
param-reflectivity = Mirror (reflectivity)
param-transparency = Transparency
param-refraction = Light bending (index)
param-metal = Kind of metal
param-base_weight = Base amount
param-base_color = Base colour
param-base_diffuse_roughness = Base roughness
param-base_metalness = Metal
param-specular_weight = Surface reflection
param-specular_color = Reflection colour
param-specular_roughness = Frosting
    .tooltip = How rough the surface is: 0 is polished, 1 is dull; glass becomes frosted.
param-specular_ior = Index of refraction
param-transmission_weight = Light let through
param-transmission_color = Tint inside
param-transmission_depth = Tint depth
param-transmission_scatter = Milky colour
param-transmission_scatter_anisotropy = Scattering forwards
param-transmission_dispersion_scale = Rainbow amount (dispersion)
param-transmission_dispersion_abbe_number = Abbe number
param-coat_weight = Coat amount
param-coat_color = Coat colour
param-coat_roughness = Coat roughness
param-coat_ior = Coat index
param-thin_film_weight = Film amount
param-thin_film_thickness = Film thickness
param-thin_film_ior = Film index
param-emission_luminance = Own light
param-emission_color = Colour of own light
param-geometry_thin_walled = Thin pane
param-base_weight_texture = Base amount by pattern
param-roughness_texture = Frosting by pattern
param-metalness_texture = Metal by pattern
param-specular_texture = Reflection by pattern
param-transmission_texture = Light let through by pattern
param-coat_texture = Coat by pattern
param-emission_texture = Own light by pattern
param-normal_map = Fine relief (normal map)
param-bump_map = Height by pattern (bump map)
param-bump_height = Relief height

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
param-bounces = Surfaces on the way
param-exposure = Exposure (stops)
param-white_balance = White balance
param-view = Display colours
param-noise = Good enough at noise
param-time_limit = Time limit
param-unpolarised = Unpolarised light
param-denoise = Remove noise
