/** Roles: which code may do what. */
@NullMarked
package org.urbi.kernel.trust;

import org.jspecify.annotations.NullMarked;
