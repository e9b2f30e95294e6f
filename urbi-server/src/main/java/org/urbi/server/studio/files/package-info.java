/** The files that people edit in a browser. */
@NullMarked
package org.urbi.server.studio.files;

import org.jspecify.annotations.NullMarked;
