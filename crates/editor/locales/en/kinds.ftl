## Names of kinds and of choices.

kind-sphere = Sphere
kind-box = Box
kind-plane = Plane
kind-triangle = Triangle
kind-mesh = Model
kind-object-disc = Disc

kind-ambient = Everywhere light (ambient)
kind-point = Bulb (point)
kind-directional = Sunlight (directional)
kind-disc = Disc lamp
kind-light-sphere = Round bulb (sphere)
kind-environment = Panorama (environment)
kind-sky = Sky and sun

kind-picture = Picture
kind-checker = Chessboard

kind-object = Object
kind-light = Light
kind-group = Group
kind-material = Material
kind-texture = Pattern
kind-camera = Camera
kind-settings = Picture

choice-renderer-classic = Classic
choice-renderer-cast = Ray casting
choice-renderer-photoreal = Photoreal
choice-view-none = by the method
choice-view-neutral = True colours (neutral)
choice-view-agx = As on film (AgX)
choice-view-srgb = Plain (sRGB)
choice-metal-gold = Gold
choice-metal-copper = Copper
choice-metal-silver = Silver
choice-metal-aluminium = Aluminium
choice-metal-chrome = Chrome
choice-wrap-repeat = Repeat
choice-wrap-clamp = Outermost colours
