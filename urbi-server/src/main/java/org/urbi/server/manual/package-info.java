/** The manual pages and completions of all programs, which packages have. */
@NullMarked
package org.urbi.server.manual;

import org.jspecify.annotations.NullMarked;
