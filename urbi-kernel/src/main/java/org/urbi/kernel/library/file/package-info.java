/**
 * Paths, files, directories and the streams to them (manual, "Path", "File", "Directory",
 * "InputStream", "OutputStream").
 */
package org.urbi.kernel.library.file;
