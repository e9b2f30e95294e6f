package org.urbi.server.studio.files;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.trust.Role;

/**
 * Where people edit files, by their role: observers nowhere.
 *
 * @param owners those of owners; null for nowhere
 * @param users those of users; null for nowhere
 */
public record Folders(@Nullable Path owners, @Nullable Path users) {
  /** Nobody edits files. */
  public static final Folders NONE = new Folders(null, null);

  /**
   * The files of a role.
   *
   * @throws FileRefused if it has none
   */
  public SourceFiles of(Role role) throws FileRefused {
    Path folder =
        switch (role) {
          case OWNER -> owners;
          case USER -> users;
          case OBSERVER -> null;
        };
    if (folder == null) {
      throw new FileRefused("the role " + role.text() + " has no files on this server");
    }
    return new SourceFiles(folder);
  }
}
