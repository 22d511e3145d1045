/** Who made a file, by its place among others: the folders of a class upload are named by students. */

/**
 * The student of each file: the first folder that not all files share, else the name of the file. What learning
 * platforms add to the names of folders (`Anna Berger_1234_assignsubmission_file_`) is left out; a file named by this page
 * has no student.
 */
export function studentsOf(paths: readonly string[]): readonly string[] {
  const split = paths.map((path) => path.split('/'));
  const [some = []] = split;
  const isShared = (folder: string, depth: number): boolean =>
    split.every((parts) => parts.length > depth + 1 && parts[depth] === folder);
  const first = some.findIndex((folder, depth) => !isShared(folder, depth));
  const shared = Math.max(0, first);
  return split.map((parts) => {
    const [name = '', ...rest] = parts.slice(shared);
    return rest.length > 0 ? name.replace(/_\d+_.*$/, '') : stemOf(name);
  });
}

/** The name of a file, without folders and ending. */
export function stemOf(path: string): string {
  const name = path.replace(/^.*\//, '').replace(/\.[^.]{1,5}$/, '');
  return /^bouncelab-drops\b/.test(name) ? '' : name;
}
