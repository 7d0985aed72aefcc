// Only there for the precompiled headers that other targets share.
