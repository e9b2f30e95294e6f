/**
 * Paths, files, directories and the streams to them (manual, "Path", "File", "Directory",
 * "InputStream", "OutputStream").
 */
@NullMarked
package org.urbi.kernel.library.file;

import org.jspecify.annotations.NullMarked;
