#!/usr/bin/env python3
"""Rasters that GDAL's own tools make: types of values, bands, masks, scales, units, coordinate systems, bodies,
orientations. terrain_routes reads each as it is, or converts it, or refuses it with the reason.

Usage: test_geotiffs.py PROGRAM [TABLE [EXPECTED]]

PROGRAM is terrain_routes, compiled with GDAL. What has become of each raster is written to TABLE, and compared with
the table EXPECTED, if it is there. Expected costs are those of straight lines, which are computed here.
"""

import difflib
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

US_FOOT = 1200 / 3937
ROWS = COLUMNS = 9
FIRST, LAST = "cell:0,4", "cell:8,4"
ACROSS = ["-s", FIRST, "-t", LAST]
HIKE = ["--cost", "hiking_time", *ACROSS]
NO_PATH = "there is no path"

# ----- what a straight line costs, along 8 cells


def seconds(unit=1.0):
    """The time to climb by 1 per 10, which is 0.6 exp(3.5 (0.1 + 0.05)) per unit of length."""
    return 80 * unit * math.sqrt(1.01) * 0.6 * math.exp(3.5 * 0.15)


def along_parallel(latitude, degrees, radius=6378137.0, flattening=1 / 298.257223563):
    square = flattening * (2 - flattening)
    sine = math.sin(math.radians(latitude))
    return radius / math.sqrt(1 - square * sine * sine) * math.cos(math.radians(latitude)) * math.radians(degrees)


# ----- rasters, in files that GDAL's tools read


def text_raster(row, name, rows=ROWS, header="xllcorner 500000\nyllcorner 5000000\ncellsize 10"):
    line = " ".join(str(value) for value in row)
    with open(name, "w") as out:
        out.write(f"ncols {len(row)}\nnrows {rows}\n{header}\n" + f"{line}\n" * rows)


def make_sources():
    """Friction 1; the same with a wall of 200; heights that climb by 1 from column to column; and a mask."""
    text_raster([1] * 9, "flat.asc")
    text_raster([1, 1, 1, 1, 200, 1, 1, 1, 1], "wall.asc")
    text_raster([1.5, 1, 1, 1, -9999.9, 1, 1, 1, 1], "wall_of_floats.asc")
    text_raster([1.5, 1, 1, 1, 1e20, 1, 1, 1, 1], "wall_of_large_floats.asc")
    text_raster(["nan" if i == 4 else 1.5 for i in range(9)], "wall_of_nan.asc")
    text_raster(range(9), "climb.asc")
    text_raster(range(-8, 1), "below_0.asc")
    text_raster([*range(248, 256), 0], "bytes_below_0.asc")
    text_raster([10 * i + 500 for i in range(9)], "tenths.asc")
    text_raster([255, 255, 255, 255, 0, 255, 255, 255, 255], "mask.asc")


def gdal(*command):
    done = subprocess.run([command[0], "-q", *command[1:]], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\nhas failed: {done.stderr}")


def translate(source, *options):
    """Makes the raster by gdal_translate."""
    return lambda name: gdal("gdal_translate", *options, source, name)


def signed_bytes(name):
    """Heights from -8 to 0, as this version of GDAL has them."""
    version = subprocess.run(["gdal_translate", "--version"], capture_output=True, text=True).stdout
    if tuple(map(int, re.search(r"(\d+)\.(\d+)", version).groups())) >= (3, 7):
        gdal("gdal_translate", "-ot", "Int8", "below_0.asc", name)
    else:
        gdal("gdal_translate", "-ot", "Byte", "-co", "PIXELTYPE=SIGNEDBYTE", "bytes_below_0.asc", name)


def virtual(*bands, dataset="", options=()):
    """Makes it from a virtual raster. A band is the file that it reads, its type, its color, and other elements."""

    def make(name):
        with open("virtual.vrt", "w") as out:
            out.write(f'<VRTDataset rasterXSize="{COLUMNS}" rasterYSize="{ROWS}">{dataset}')
            for i, (source, kind, color, more) in enumerate(bands):
                out.write(
                    f'<VRTRasterBand dataType="{kind}" band="{i + 1}"><ColorInterp>{color}</ColorInterp>{more}'
                    f'<SimpleSource><SourceFilename relativeToVRT="1">{source}</SourceFilename>'
                    "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>"
                )
            out.write("</VRTDataset>")
        gdal("gdal_translate", *options, "virtual.vrt", name)

    return make


def with_mask(*options):
    """A band, and another one as its mask, within the file or beside it."""
    source = virtual(("flat.asc", "Byte", "Gray", ""), ("mask.asc", "Byte", "Undefined", ""))

    def make(name):
        source("both.tif")
        gdal("gdal_translate", "-b", "1", "-mask", "2", *options, "both.tif", name)

    return make


def created(columns, rows, *bounds):
    """Friction 1 in degrees, by gdal_create."""
    return lambda name: gdal(
        "gdal_create", "-ot", "Byte", "-burn", "1", "-outsize", str(columns), str(rows), "-a_srs", "EPSG:4326",
        "-a_ullr", *map(str, bounds), name,
    )  # fmt: skip


def rounded_earth(name):
    """Two rows at the equator, of cells that are 360 degrees but for rounding."""
    text_raster([1] * 4320, "raster.asc", 2, "xllcorner -180\nyllcorner -0.083333\ncellsize 0.083333")


def warped(*options):
    """Nine columns of 10 m, transformed to another system."""

    def make(name):
        gdal("gdal_translate", "-a_srs", "EPSG:32632", "flat.asc", "plane.tif")
        gdal("gdalwarp", "-overwrite", *options, "plane.tif", name)

    return make


UTM = ("-a_srs", "EPSG:32632")
ALPHA = (("flat.asc", "Byte", "Gray", ""), ("mask.asc", "Byte", "Alpha", ""))
PALETTE = "<ColorTable>" + '<Entry c1="9" c2="9" c3="9" c4="255"/>' * 256 + "</ColorTable>"
GRADS = (
    'GEOGCS["grads",DATUM["d",SPHEROID["Clarke",6378249.2,293.4660212936269]],PRIMEM["Greenwich",0],'
    'UNIT["grad",0.01570796326794897]]'
)
ALIEN_LATITUDES = ("-a_ullr", "10", "0.045", "10.09", "-0.045")  # cells of 0.01, the fifth row at the equator
LOCAL = 'LOCAL_CS["site",UNIT["metre",1]]'

# ----- cases: what the raster is, how it is made, what comes of it, and the arguments: a cost, or words

CASES = [
    *(
        (f"values of type {kind}", translate("wall.asc", "-ot", kind, "-a_nodata", "200"), "read",
         rf"friction, {kind}; 9 cells without data \(by the value 200\).*{NO_PATH}", ["RASTER", *ACROSS])
        for kind in ("Byte", "UInt16", "Int16", "UInt32", "Int32", "Float32", "Float64")
    ),
    ("signed bytes", signed_bytes, "read", seconds(),
     ["--heights", "RASTER", *HIKE]),
    *(
        (f"values of type {kind}", translate("flat.asc", "-ot", kind), "refused", "complex numbers",
         ["RASTER", *ACROSS])
        for kind in ("CInt16", "CFloat64")
    ),
    ("a table of colors", virtual(("flat.asc", "Byte", "Palette", PALETTE)), "read",
     "indices of a table of colors.*cost 8,", ["RASTER", *ACROSS]),
    ("compressed, in tiles", translate("flat.asc", *UTM, "-co", "TILED=YES", "-co", "COMPRESS=DEFLATE"), "read", 80,
     ["RASTER", *ACROSS]),
    # bands
    ("two bands, of which one is chosen",
     virtual(("flat.asc", "Byte", "Gray", ""), ("wall.asc", "Byte", "Undefined", "")), "read",
     "band 2 of 2.*cost 207,", ["RASTER", *ACROSS, "--band", "2"]),
    ("two bands, and the third is chosen",
     virtual(("flat.asc", "Byte", "Gray", ""), ("wall.asc", "Byte", "Undefined", "")), "refused",
     "it has 2 bands, and no band 3", ["RASTER", *ACROSS, "--band", "3"]),
    ("red, green and blue", virtual(*(("flat.asc", "Byte", c, "") for c in ("Red", "Green", "Blue"))), "refused",
     r"its band 1 of 3 is a color \(Red\)", ["RASTER", *ACROSS]),
    ("red, green and blue, of which one is chosen",
     virtual(*(("flat.asc", "Byte", c, "") for c in ("Red", "Green", "Blue"))), "read", "band 2 of 3.*cost 8,",
     ["RASTER", *ACROSS, "--band", "2"]),
    # what hides cells
    ("an alpha band", virtual(*ALPHA), "read", rf"9 cells without data \(by an alpha band\).*{NO_PATH}",
     ["RASTER", *ACROSS]),
    ("an alpha band that is chosen", virtual(*ALPHA), "refused", "its band 2 of 2 tells what is transparent",
     ["RASTER", *ACROSS, "--band", "2"]),
    ("an alpha band of 16 bits",
     virtual(("flat.asc", "UInt16", "Gray", ""), ("mask.asc", "UInt16", "Alpha", "")), "read",
     rf"9 cells without data \(by an alpha band\).*{NO_PATH}", ["RASTER", *ACROSS]),
    ("an alpha band beside a value for no data", virtual(*ALPHA, options=("-a_nodata", "7")), "read",
     rf"9 cells without data \(by the value 7, and by an alpha band\).*{NO_PATH}", ["RASTER", *ACROSS]),
    ("a mask within the file", with_mask("--config", "GDAL_TIFF_INTERNAL_MASK", "YES"), "read",
     rf"9 cells without data \(by a mask\).*{NO_PATH}", ["RASTER", *ACROSS]),
    ("a mask in a file beside it", with_mask("--config", "GDAL_TIFF_INTERNAL_MASK", "NO"), "read",
     rf"9 cells without data \(by a mask\).*{NO_PATH}", ["RASTER", *ACROSS]),
    ("a mask beside another value for no data", with_mask(), "read",
     rf"9 cells without data \(by the value 7, and by a mask\).*{NO_PATH}", ["RASTER", *ACROSS, "--no-data", "7"]),
    ("no data where all bands have values for it",
     virtual(("wall.asc", "Byte", "Gray", ""), ("mask.asc", "Byte", "Undefined", ""),
             dataset='<Metadata><MDI key="NODATA_VALUES">200 0</MDI></Metadata>'), "read",
     rf"9 cells without data \(by values for no data in all bands\).*{NO_PATH}", ["RASTER", *ACROSS]),
    ("-9999.9 for no data, which is no float", translate("wall_of_floats.asc", "-ot", "Float32", "-a_nodata", "-9999.9"),
     "read", f"9 cells without data.*{NO_PATH}", ["RASTER", *ACROSS]),
    ("the same value by an option", translate("wall_of_floats.asc", "-ot", "Float32"), "read",
     f"9 cells without data.*{NO_PATH}", ["RASTER", *ACROSS, "--no-data", "-9999.9"]),
    ("1e20 for no data, which is no float", translate("wall_of_large_floats.asc", "-ot", "Float32", "-a_nodata", "1e20"),
     "read", f"9 cells without data.*{NO_PATH}", ["RASTER", *ACROSS]),
    ("NaN for no data", translate("wall_of_nan.asc", "-ot", "Float32", "-a_nodata", "nan"), "read",
     f"9 cells without data.*{NO_PATH}", ["RASTER", *ACROSS]),
    ("NaN without being told that it is no data",
     translate("wall_of_nan.asc", "-ot", "Float32", "-a_nodata", "none"), "refused",
     r"the cost of cell 4,0 \(column, row\) is nan", ["RASTER", *ACROSS]),
    ("a source in a cell without data", translate("wall.asc", "-a_nodata", "200", *UTM), "refused",
     "--sources: cell 4,4 cannot be entered, .*the nearest cell that can be is 3,4, 10 m away",
     ["RASTER", "-s", "cell:4,4"]),
    ("a source in a cell without data, moved", translate("wall.asc", "-a_nodata", "200", *UTM), "read",
     "The source cell 4,4 cannot be entered; moved by 10 m to cell 3,4.*cost 30,",
     ["RASTER", "-s", "cell:4,4", "-t", "cell:0,4", "--snap"]),
    # scales and units
    ("heights with a scale and an offset",
     translate("tenths.asc", "-ot", "Int16", "-a_scale", "0.1", "-a_offset", "-50", *UTM), "converted", seconds(),
     ["--heights", "RASTER", *HIKE]),
    ("a scale of 0", translate("tenths.asc", "-ot", "Int16", "-a_scale", "0", *UTM), "refused", "the scale 0",
     ["--heights", "RASTER", *HIKE]),
    ("US survey feet", translate("climb.asc", "-a_srs", "EPSG:3566"), "converted", seconds(US_FOOT),
     ["--heights", "RASTER", *HIKE]),
    ("international feet", translate("flat.asc", "-a_srs", "EPSG:2222"), "converted", 80 * 0.3048,
     ["RASTER", *ACROSS]),
    ("kilometers", translate("flat.asc", "-a_srs", "+proj=utm +zone=32 +units=km +ellps=GRS80"), "converted", 80000,
     ["RASTER", *ACROSS]),
    ("heights in feet on a map in meters",
     virtual(("climb.asc", "Float64", "Gray", f"<UnitType>ft</UnitType><Scale>{1 / 0.3048!r}</Scale>"),
             dataset="<GeoTransform>500000,10,0,5000090,0,-10</GeoTransform>", options=UTM), "converted", seconds(),
     ["--heights", "RASTER", *HIKE]),
    ("heights in fathoms",
     virtual(("climb.asc", "Float64", "Gray", "<UnitType>fathom</UnitType>"),
             dataset="<GeoTransform>500000,10,0,5000090,0,-10</GeoTransform>", options=UTM), "refused",
     '--height-unit: .* has heights in "fathom"', ["--heights", "RASTER", *HIKE]),
    ("heights in feet by their part of the coordinate system",
     translate("climb.asc", "-a_srs", "EPSG:26912+6360", "-a_scale", repr(1 / US_FOOT), "-a_offset", "0"), "converted",
     seconds(), ["--heights", "RASTER", *HIKE]),
    ("heights in feet by their own coordinate system, beside friction on the plane",
     translate("flat.asc", "-a_srs", "EPSG:26912"),
     "converted", seconds(), ["RASTER", "--heights", "OTHER", *HIKE],
     translate("climb.asc", "-of", "VRT", "-a_srs", "EPSG:26912+6360", "-a_scale", repr(1 / US_FOOT), "-a_offset", "0")),
    ("feet in the coordinate system of friction are not those of heights",
     translate("flat.asc", "-of", "VRT", "-a_srs", "EPSG:26912+6360"),
     "read", seconds(), ["RASTER", "--heights", "OTHER", *HIKE],
     translate("climb.asc", "-of", "VRT", "-a_srs", "EPSG:26912")),
    ("heights in feet on a map without a system",
     virtual(("climb.asc", "Float64", "Gray", "<UnitType>ft</UnitType>"),
             dataset="<GeoTransform>0,10,0,90,0,-10</GeoTransform>"), "refused",
     "--unit: .* has heights in ft, and tells of no coordinate system", ["--heights", "RASTER", *HIKE]),
    # coordinate systems
    ("no coordinate system", translate("climb.asc"), "read", "as they are taken for meters.*cost 81.54",
     ["--heights", "RASTER", *HIKE]),
    ("no coordinate system, and an option", translate("flat.asc"), "converted", 80 * 0.3048,
     ["RASTER", *ACROSS, "--unit", "ft"]),
    ("no coordinate system, with coordinates of centers",
     translate("climb.asc", "-mo", "AREA_OR_POINT=Point"), "read",
     "no coordinate system.*as they are taken for meters.*cost 81.54", ["--heights", "RASTER", *HIKE]),
    ("a local system", translate("flat.asc", "-a_srs", LOCAL), "read", 80, ["RASTER", *ACROSS]),
    ("Web Mercator", translate("flat.asc", "-a_srs", "EPSG:3857", "-a_ullr", "0", "8400000", "90", "8399910"),
     "read", r"lengths on the map are 1\.99[0-9]* to 1\.99[0-9]* times those on the ground.*cost 80,", ["RASTER", *ACROSS]),
    ("a system of three coordinates from the Earth's center", translate("flat.asc", "-a_srs", "EPSG:4978"), "refused",
     "its coordinate system, .*, is neither geographic, nor projected", ["RASTER", *ACROSS]),
    ("Web Mercator, round the Earth",
     translate("flat.asc", "-a_srs", "EPSG:3857", "-a_ullr", "-20037508.3427892", "8400000", "20037508.3427892",
               "-8400000"), "read",
     r"map are 1 to 2\.[0-9]* times those on the ground\nRound the Earth: no path leads from the last column",
     ["RASTER", *ACROSS]),
    ("degrees", created(9, 9, 10, 50.45, 10.9, 49.55), "converted", along_parallel(50, 0.8), ["RASTER", *ACROSS]),
    ("degrees, by gdalwarp", warped("-t_srs", "EPSG:4326", "-ts", "9", "9"), "converted", "cost [67]",
     ["RASTER", *ACROSS]),
    ("grads", translate("flat.asc", "-a_srs", GRADS, "-a_ullr", "10", "50.045", "10.09", "49.955"), "converted",
     along_parallel(45, 0.08 * 0.9, 6378249.2, 1 / 293.4660212936269), ["RASTER", *ACROSS]),
    ("the Moon", translate("flat.asc", "-a_srs", "+proj=longlat +R=1737400", *ALIEN_LATITUDES), "converted",
     along_parallel(0, 0.08, 1737400, 0), ["RASTER", *ACROSS]),
    ("Mars", translate("flat.asc", "-a_srs", "+proj=longlat +a=3396190 +b=3376200", *ALIEN_LATITUDES), "converted",
     along_parallel(0, 0.08, 3396190), ["RASTER", *ACROSS]),
    ("friction of the Moon beside heights of the Earth",
     translate("flat.asc", "-a_srs", "+proj=longlat +R=1737400", *ALIEN_LATITUDES), "refused",
     "its coordinate system, .* is not that of the raster of friction", ["RASTER", "--heights", "OTHER", *ACROSS],
     translate("climb.asc", "-a_srs", "EPSG:4326", *ALIEN_LATITUDES)),
    ("friction without a system beside heights in degrees", translate("flat.asc", *ALIEN_LATITUDES), "refused",
     "--degrees: .* tells of no coordinate system, and .* is in degrees", ["RASTER", "--heights", "OTHER", *ACROSS],
     translate("climb.asc", "-a_srs", "EPSG:4326", *ALIEN_LATITUDES)),
    ("the same, and an option", translate("flat.asc", *ALIEN_LATITUDES), "converted",
     along_parallel(0, 0.08), ["RASTER", "--heights", "OTHER", *ACROSS, "--degrees"],
     translate("flat.asc", "-a_srs", "EPSG:4326", *ALIEN_LATITUDES)),
    ("the same system with and without heights", translate("flat.asc", "-a_srs", "EPSG:26912"), "read",
     seconds(), ["RASTER", "--heights", "OTHER", *HIKE], translate("climb.asc", "-a_srs", "EPSG:26912+5703")),
    ("degrees with and without ellipsoidal heights",
     translate("flat.asc", "-a_srs", "EPSG:4326", *ALIEN_LATITUDES), "converted",
     along_parallel(0, 0.08), ["RASTER", "--heights", "OTHER", *ACROSS],
     translate("flat.asc", "-a_srs", "EPSG:4979", *ALIEN_LATITUDES)),
    # places on the map
    ("the first row in the south", translate("flat.asc", *UTM, "-a_ullr", "0", "0", "90", "90"), "read",
     "y from 0 to 90 m.*cost 80,", ["RASTER", *ACROSS]),
    ("the first column in the east", translate("flat.asc", *UTM, "-a_ullr", "90", "90", "0", "0"), "read",
     "x from 0 to 90, y.*cost 80,", ["RASTER", *ACROSS]),
    ("turned", virtual(("flat.asc", "Byte", "Gray", ""), dataset="<GeoTransform>0,8,6,0,6,-8</GeoTransform>"),
     "refused", "its rows do not run along the x axis", ["RASTER", *ACROSS]),
    ("turned by rounding",
     virtual(("flat.asc", "Byte", "Gray", ""), dataset="<GeoTransform>0,10,1e-13,90,-1e-13,-10</GeoTransform>"),
     "read", "cost 80,", ["RASTER", *ACROSS]),
    ("control points",
     virtual(("flat.asc", "Byte", "Gray", ""), dataset='<GCPList Projection="EPSG:4326">'
             '<GCP Id="1" Pixel="0" Line="0" X="10" Y="50"/><GCP Id="2" Pixel="9" Line="0" X="11" Y="51"/>'
             '<GCP Id="3" Pixel="0" Line="9" X="10" Y="49"/></GCPList>'),
     "refused", "control points tell where its cells are", ["RASTER", *ACROSS]),
    ("a system without a place", virtual(("flat.asc", "Byte", "Gray", ""), dataset="<SRS>EPSG:32632</SRS>"), "refused",
     "--cell-size: .* does not tell how large its cells are", ["RASTER", *ACROSS]),
    ("cells of 10 by 20", translate("flat.asc", *UTM, "-a_ullr", "0", "180", "90", "0"), "read",
     "Cells: 10 m by 20 m.*cost 160,", ["RASTER", "-s", "cell:4,0", "-t", "cell:4,8"]),
    # round the Earth
    ("the Earth from -180 to 180 degrees", created(360, 180, -180, 90, 180, -90), "converted",
     along_parallel(0.5, 2), ["RASTER", "-s", "cell:359,89", "-t", "cell:1,89"]),
    ("the Earth from 0 to 360 degrees", created(720, 360, 0, 90, 360, -90), "converted",
     along_parallel(0.25, 1), ["RASTER", "-s", "cell:719,179", "-t", "cell:1,179"]),
    ("the Earth with cells of a rounded size", rounded_earth, "converted",
     along_parallel(0.0416665, 2 / 12), ["raster.asc", "--degrees", "-s", "cell:4319,0", "-t", "cell:1,0"]),
    ("longitudes of another turn", created(20, 9, 170, 4.5, 190, -4.5), "converted",
     along_parallel(0, 8), ["RASTER", "-s", "-178.5,0", "-t", "cell:19,4"]),
    ("the Earth but for a degree", created(359, 180, -180, 90, 179, -90), "converted",
     along_parallel(0.5, 8), ["RASTER", "-s", "cell:350,89", "-t", "cell:358,89"]),
    ("the Earth and a degree more", created(361, 180, -180, 90, 181, -90), "refused", "longitudes go from -180 to 181, more than once round",
     ["RASTER", "-s", "cell:359,89"]),
    ("latitudes in grads beyond the poles", translate("flat.asc", "-a_srs", GRADS, "-a_ullr", "10", "110", "19", "101"),
     "refused", "latitudes go from 90.9 to 99; they must be from -90 to 90 degrees", ["RASTER", *ACROSS]),
    ("latitudes beyond the poles", created(9, 9, 0, 95, 9, 86), "refused", "latitudes go from 86 to 95",
     ["RASTER", "-s", "cell:0,0"]),
]  # fmt: skip


def check(program, what, make, kind, expected, arguments, make_other=None):
    """Makes a raster and asks for a path. Returns the lines of the program, or None if they are wrong."""
    make("raster.tif")
    if make_other:
        make_other("other.tif")
    names = {"RASTER": "raster.tif", "OTHER": "other.tif"}
    done = subprocess.run(
        [program, *(names.get(word, word) for word in arguments), "--output", "out", "--force"],
        capture_output=True, text=True,
    )  # fmt: skip
    output = done.stdout if done.returncode == 0 else done.stderr
    is_right = (done.returncode != 0) == (kind == "refused")
    if isinstance(expected, str):
        is_right = is_right and re.search(expected, output, re.DOTALL) is not None
    else:
        cost = re.search("cost ([0-9.e+]+)", output)
        is_right = is_right and cost is not None and math.isclose(float(cost[1]), expected, rel_tol=2e-5)
    if not is_right:
        print(f"{what}: {kind} was expected, {expected}\n{' '.join(arguments)}\n{done.stdout}{done.stderr}")
        return None
    output = re.sub(r" in [0-9.e-]+ s$", "", output.replace("terrain_routes: ", ""), flags=re.MULTILINE)
    return [line for line in output.splitlines() if line and not line.startswith(("Written", "Largest"))]


def differences(table, expected):
    """Lines that differ from the table that is kept, which is not part of an installation."""
    if not expected or not pathlib.Path(expected).exists():
        return []
    kept = pathlib.Path(expected).read_text().splitlines()
    return list(difflib.unified_diff(kept, table.read_text().splitlines(), expected, str(table), n=0, lineterm=""))


def main(program, table=None, expected=None):
    for tool in ("gdal_translate", "gdal_create", "gdalwarp"):
        if not shutil.which(tool):
            print(f"NOTICE: {tool} is missing (Debian: gdal-bin), so rasters of GDAL are not tested.")
            return 0
    program, table = pathlib.Path(program).resolve(), table and pathlib.Path(table).resolve()
    lines, number_wrong = [], 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        make_sources()
        for case in CASES:
            for file in pathlib.Path(".").glob("raster.*"):
                file.unlink()
            told = check(program, *case)
            number_wrong += told is None
            number = sum(line[0] != " " for line in lines) + 1
            lines += [f"{number}. {case[0]}: {case[2]}", *("    " + line for line in told or ["not as expected"])]
        os.chdir("/")
    kinds = [case[2] for case in CASES]
    summary = ", ".join(f"{kinds.count(kind)} {kind}" for kind in ("read", "converted", "refused"))
    print(f"{len(CASES)} rasters: {summary}; {number_wrong} not as expected")
    if table:
        table.write_text(f"# Output of {pathlib.Path(__file__).name}: {summary}\n" + "\n".join(lines) + "\n")
    differing = differences(table, expected) if table else []
    print(*differing, sep="\n", end="\n" if differing else "")
    return 1 if number_wrong or differing else 0


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
