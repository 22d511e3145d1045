/** A sound card without hardware: where nothing can be played, Firefox does not run what listens either. */
import { execFileSync } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

/** Starts a PulseAudio of the tests alone, which goes to the background when it is ready; the answer ends it. */
export default function setup(): () => void {
  const folder = mkdtempSync(join(tmpdir(), 'sound-server-'));
  const socket = join(folder, 'socket');
  const env = { ...process.env, HOME: folder, XDG_RUNTIME_DIR: folder, PULSE_RUNTIME_PATH: folder };
  const pulseaudio = (...words: string[]) =>
    execFileSync('pulseaudio', words, { env, stdio: 'ignore' });
  pulseaudio(
    ...['-n', '--daemonize=yes', '--exit-idle-time=-1', '--disable-shm=yes'],
    `--load=module-native-protocol-unix socket=${socket}`,
    '--load=module-null-sink',
  );
  process.env['PULSE_SERVER'] = `unix:${socket}`;
  return () => pulseaudio('--kill');
}
