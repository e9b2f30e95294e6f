/** The syntax tree of urbiscript. */
@NullMarked
package org.urbi.lang.ast;

import org.jspecify.annotations.NullMarked;
