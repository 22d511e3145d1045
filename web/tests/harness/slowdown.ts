/**
 * How many times slower than it is the page is made: a test that reads it before the state that it asks for then fails
 * nearly always, instead of now and then. `cargo xtask web e2e --slowdown` states it. Firefox only gets its files later.
 */
export const SLOWDOWN = Number(process.env['BOUNCELAB_SLOWDOWN'] ?? 1);
