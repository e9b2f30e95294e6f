package org.urbi.kernel.library.system;

import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Where source files are looked for.
 *
 * @param folders first to last
 * @param library the folder of the library's own source files; null when there is none
 */
public record SearchPath(List<Path> folders, @Nullable Path library) {}
