//! What a bounce keeps: restitution laws and contact time.
